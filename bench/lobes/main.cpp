// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT

// Draws a fibre's lobes as a PNG of four panels: along the fibre (M), round it (N), both as a cut through the whole
// lobe in the plane of fibre and light, and the map of the sphere in the colours that leave.
#include <lobes/lobe_model.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace pelage;
using bench::lobe_model;
using bench::lobe_settings;

constexpr double pi = std::numbers::pi;
constexpr int thetas = 180;
constexpr int phis = 360;

/// Every lobe at every degree of the sphere.
struct sphere_of_lobes {
  explicit sphere_of_lobes(const lobe_model& model) : lobe(model.names().size()) {
    for (int i = 0; i < thetas; ++i) {
      for (int k = 0; k < phis; ++k) {
        const std::vector<glm::dvec3> values = model(theta(i), phi(k));
        for (std::size_t p = 0; p < lobe.size(); ++p) {
          lobe[p].push_back(values[p]);
        }
      }
    }
  }

  static double theta(int i) { return ((i + 0.5) / thetas - 0.5) * pi; }
  static double phi(int k) { return ((k + 0.5) / phis - 0.5) * 2.0 * pi; }

  [[nodiscard]] glm::dvec3 sum(int i, int k) const {
    glm::dvec3 total(0.0);
    for (const auto& each : lobe) {
      total += each[static_cast<std::size_t>(i * phis + k)];
    }
    return total;
  }

  /// A lobe's mean of the three channels.
  [[nodiscard]] double grey(std::size_t p, int i, int k) const {
    const glm::dvec3& c = lobe[p][static_cast<std::size_t>(i * phis + k)];
    return (c.x + c.y + c.z) / 3.0;
  }

  std::vector<std::vector<glm::dvec3>> lobe;
};

/// Light per radian of inclination (all azimuths), for each lobe.
std::string along_data(const sphere_of_lobes& sphere) {
  std::string text;
  for (int i = 0; i < thetas; ++i) {
    text += fmt::format("{:.6g}", sphere_of_lobes::theta(i) * 180.0 / pi);
    for (std::size_t p = 0; p < sphere.lobe.size(); ++p) {
      double row = 0.0;
      for (int k = 0; k < phis; ++k) {
        row += sphere.grey(p, i, k) * 2.0 * pi / phis;
      }
      text += fmt::format(" {:.6g}", row * std::cos(sphere_of_lobes::theta(i)));
    }
    text += '\n';
  }
  return text;
}

/// Light per radian of azimuth (all inclinations), for each lobe and all together; x points back to the light.
std::string round_data(const sphere_of_lobes& sphere, const lobe_model& model) {
  std::string text;
  for (int k = 0; k <= phis; ++k) {
    const int column = k % phis;
    std::string line = fmt::format("{:.6g}", sphere_of_lobes::phi(column) * 180.0 / pi);
    double total = 0.0;
    for (std::size_t p = 0; p < sphere.lobe.size(); ++p) {
      double sum = 0.0;
      for (int i = 0; i < thetas; ++i) {
        sum += sphere.grey(p, i, column) * std::cos(sphere_of_lobes::theta(i)) * pi / thetas;
      }
      line += fmt::format(" {:.6g}", sum);
      total += sum;
    }
    const double near = model.has_near_field() ? model.near_field_averaged(sphere_of_lobes::phi(column)) : 0.0;
    text += line + fmt::format(" {:.6g} {:.6g}\n", total, near);
  }
  return text;
}

/// The whole lobe in the plane of fibre and light: angle from the light's side of the normal plane round by the tip.
std::string cut_data(const sphere_of_lobes& sphere) {
  std::string text;
  const auto line = [&](double angle, int i, int k) {
    text += fmt::format("{:.6g}", angle);
    double total = 0.0;
    for (std::size_t p = 0; p < sphere.lobe.size(); ++p) {
      text += fmt::format(" {:.6g}", sphere.grey(p, i, k));
      total += sphere.grey(p, i, k);
    }
    text += fmt::format(" {:.6g}\n", total);
  };
  for (int i = 0; i < thetas; ++i) {
    line(sphere_of_lobes::theta(i) * 180.0 / pi, i, phis / 2);
  }
  for (int i = thetas - 1; i >= 0; --i) {
    line(180.0 - sphere_of_lobes::theta(i) * 180.0 / pi, i, 0);
  }
  line(sphere_of_lobes::theta(0) * 180.0 / pi, 0, phis / 2);
  return text;
}

/// Colours of the sphere in sRGB, by a factor that leaves one part in a hundred white.
std::string map_data(const sphere_of_lobes& sphere) {
  std::vector<double> brightest;
  for (int i = 0; i < thetas; ++i) {
    for (int k = 0; k < phis; ++k) {
      const glm::dvec3 c = sphere.sum(i, k);
      brightest.push_back(std::max({c.x, c.y, c.z}));
    }
  }
  std::nth_element(brightest.begin(), brightest.end() - thetas * phis / 100, brightest.end());
  const double scale = 1.0 / std::max(brightest[brightest.size() - thetas * phis / 100], 1e-12);
  const auto encode = [&](double linear) {
    const double x = std::min(linear * scale, 1.0);
    return static_cast<int>(std::lround(255.0 * (x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055)));
  };
  std::string text;
  for (int i = 0; i < thetas; ++i) {
    for (int k = 0; k < phis; ++k) {
      const glm::dvec3 c = sphere.sum(i, k);
      text += fmt::format("{:.6g} {:.6g} {} {} {}\n", sphere_of_lobes::phi(k) * 180.0 / pi,
                          sphere_of_lobes::theta(i) * 180.0 / pi, encode(c.x), encode(c.y), encode(c.z));
    }
  }
  return text;
}

/// One curve per lobe, then the sum. In polar plots the radius is the root, so that a weak lobe can be seen beside TT.
std::string curves(const char* data, const lobe_model& model, bool polar) {
  const std::vector<const char*> colours = {"#c0392b", "#2471a3", "#b9770e", "#7d3c98"};
  std::string text = "plot ";
  for (std::size_t p = 0; p < model.names().size(); ++p) {
    text += fmt::format("{}{} using 1:({}(${})) with lines lw 2 lc rgb '{}' title '{}'", p == 0 ? "" : ", ", data,
                        polar ? "sqrt" : "", p + 2, colours[p], model.names()[p]);
  }
  if (polar) {
    text += fmt::format(", {} using 1:(sqrt(${})) with lines lw 1 dt 2 lc rgb 'black' title 'all'", data,
                        model.names().size() + 2);
  }
  return text + "\n";
}

/// The azimuths, with the near field averaged by brute force over the sum where a model has one.
std::string near_field(const lobe_model& model) {
  std::string text = curves("$round", model, true);
  if (model.has_near_field()) {
    text.insert(text.size() - 1, fmt::format(", $round using 1:(sqrt(${})) every 4 with points pt 7 ps 0.4 lc rgb "
                                             "'#1e8449' title 'near, averaged'",
                                             model.names().size() + 3));
  }
  return text;
}

std::string polar_frame(const char* title) {
  return fmt::format(
      "reset\nset polar\nset angles degrees\nunset border\nunset xtics\nunset ytics\nunset raxis\nset rtics format ''\n"
      "set grid polar 30\nset size square\nset key outside right top samplen 2\nset title \"{}\"\n",
      title);
}

std::string script(const lobe_settings& settings, const std::string& title, const std::string& out,
                   const lobe_model& model) {
  const sphere_of_lobes sphere(model);
  std::string text = fmt::format(
      "set terminal pngcairo size 1200,1040 font 'DejaVu Sans,11' background 'white'\nset output '{}'\n"
      "$along << END\n{}END\n$round << END\n{}END\n$cut << END\n{}END\n$map << END\n{}END\n",
      out, along_data(sphere), round_data(sphere, model), cut_data(sphere), map_data(sphere));
  text += fmt::format("set multiplot layout 2,2 margins 0.07,0.97,0.07,0.90 spacing 0.09,0.12 title \"{}\"\n", title);
  text += fmt::format(
      "set title 'M: along the fibre (light at {:.0f}°)'\nset xlabel 'inclination θ, degrees (+ to the tip)'\n"
      "set ylabel 'share of light per radian (root scale)'\nset xrange [-90:90]\nset yrange [0:*]\nset xtics 30\n"
      "set nonlinear y via sqrt(y) inverse y**2\nset ytics (0, 0.01, 0.05, 0.2, 0.5, 1, 2, 4, 8)\nset key top right\n",
      settings.theta_i * 180.0 / pi);
  text += curves("$along", model, false);
  text += polar_frame("N: round the fibre, radius √ (light from the right)") + near_field(model);
  text += polar_frame("Cut along fibre and light, radius √ (tip up, light from the right)") + "unset key\n" +
          curves("$cut", model, true);
  text += fmt::format(
      "reset\nset title 'The sphere, in the colours that leave'\nset xrange [-180:180]\nset yrange [-90:90]\n"
      "set xtics 60\nset ytics 30\nset size ratio 0.5\nset xlabel 'azimuth φ (0: back to the light)'\n"
      "set ylabel 'inclination θ'\nunset key\n"
      "plot $map using 1:2:3:4:5 with rgbimage, '+' using (0):({:.4g}) every 500 with points pt 2 ps 1.5 lc rgb "
      "'white'\n"
      "unset multiplot\n",
      settings.theta_i * 180.0 / pi);
  return text;
}

bool draw(const std::string& commands) {
  std::FILE* gnuplot = popen("gnuplot", "w");
  if (gnuplot == nullptr) {
    return false;
  }
  const bool written = std::fwrite(commands.data(), 1, commands.size(), gnuplot) == commands.size();
  return pclose(gnuplot) == 0 && written;
}

}  // namespace

int main(int count, char** words) {
  CLI::App app("Draws the lobes of a fibre as a PNG");
  lobe_settings settings;
  std::string colour = "blond";
  std::string out = "lobes.png";
  std::vector<double> pigment;
  double tilt = 2.0;
  double theta = 20.0;
  app.add_option("--bsdf", settings.model, "scattering model")
      ->check(CLI::IsMember({"chiang", "marschner", "kajiya_kay"}))
      ->capture_default_str();
  app.add_option("--colour", colour, "preset")
      ->check(CLI::IsMember({"clear", "blond", "red", "brown", "black"}))
      ->capture_default_str();
  app.add_option("--melanin", pigment, "eumelanin and pheomelanin in place of a preset")
      ->expected(2)
      ->check(CLI::NonNegativeNumber);
  app.add_option("--eta", settings.eta, "index of refraction")->check(CLI::Range(1.0, 3.0))->capture_default_str();
  app.add_option("--beta-m", settings.beta_m, "roughness along")->check(CLI::Range(0.01, 1.0))->capture_default_str();
  app.add_option("--beta-n", settings.beta_n, "roughness round")->check(CLI::Range(0.01, 1.0))->capture_default_str();
  app.add_option("--tilt", tilt, "tilt of the cuticle's scales towards the tip, degrees")
      ->check(CLI::Range(-20.0, 20.0))
      ->capture_default_str();
  app.add_option("--theta", theta, "inclination of the light, degrees")
      ->check(CLI::Range(-89.0, 89.0))
      ->capture_default_str();
  app.add_option("--out", out, "the picture")->capture_default_str();
  CLI11_PARSE(app, count, words);

  settings.tilt = tilt * pi / 180.0;
  settings.theta_i = theta * pi / 180.0;
  melanin<double> chosen = {0.0, 0.0};
  if (!pigment.empty()) {
    chosen = {pigment[0], pigment[1]};
    colour = fmt::format("melanin {:g} {:g}", pigment[0], pigment[1]);
  } else if (colour != "clear") {
    chosen = melanin_of<double>(colour == "blond"   ? hair_colour::blond
                                : colour == "red"   ? hair_colour::red
                                : colour == "brown" ? hair_colour::brown
                                                    : hair_colour::black);
  }
  settings.sigma_a = absorption_of(chosen);
  if (out.find('\'') != std::string::npos) {
    std::fputs("pelage-lobes: the picture's name may not hold an apostrophe\n", stderr);
    return 2;
  }
  std::string name = settings.model;
  std::replace(name.begin(), name.end(), '_', '-');
  // Kajiya and Kay's fibre has no index, Marschner's is smooth round its axis.
  const std::string index = settings.model == "kajiya_kay" ? "" : fmt::format("η {:g}, ", settings.eta);
  const std::string round = settings.model == "marschner" ? "" : fmt::format("β_n {:g}, ", settings.beta_n);
  const std::string title =
      fmt::format("{}, {}: {}β_m {:g}, {}tilt {:g}°", name, colour, index, settings.beta_m, round, tilt);
  const lobe_model model(settings);
  if (!draw(script(settings, title, out, model))) {
    fmt::print(stderr, "pelage-lobes: gnuplot did not draw {}\n", out);
    return 1;
  }
  return 0;
}
