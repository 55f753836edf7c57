// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The sink that a resolving shader is compiled for. Both have sink_begin(), sink_lose() for a fragment that is not
// kept, sink_keep() for one that is, nearest first, and sink_finish().
#ifdef FOR_CAMERA
#include "camera_sink.glsl"
#else
#include "light_sink.glsl"
#endif
