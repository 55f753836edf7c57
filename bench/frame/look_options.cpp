// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/look_options.hpp"

#include <map>
#include <stdexcept>

#include "frame/option_names.hpp"

namespace pelage::frame {
namespace {

const std::map<std::string, bsdf_model> model_names{{"kajiya_kay", bsdf_model::kajiya_kay},
                                                    {"marschner", bsdf_model::marschner},
                                                    {"chiang", bsdf_model::chiang},
                                                    {"dual_scattering", bsdf_model::dual_scattering}};
const std::map<std::string, hair_colour> colour_names{{"blond", hair_colour::blond},
                                                      {"red", hair_colour::red},
                                                      {"brown", hair_colour::brown},
                                                      {"black", hair_colour::black}};
const std::map<std::string, attenuation> attenuation_names{{"constant", attenuation::constant},
                                                           {"fresnel", attenuation::fresnel}};

}  // namespace

void add_look_options(CLI::App& app, look_options& o, fibre_look& look) {
  app.add_option("--bsdf", o.model, "how a fibre scatters light")
      ->check(CLI::IsMember(names(model_names)))
      ->capture_default_str();
  app.add_option(
         "--attenuation", o.passing,
         "what a fibre lets pass: constant, 1 less the model's opacity or --alpha, or fresnel, by --eta and the "
         "fibre's inclination to each ray")
      ->check(CLI::IsMember(names(attenuation_names)))
      ->capture_default_str();
  CLI::Option* colour =
      app.add_option("--hair-colour", o.colour, "pigment by name; without it and --melanin the model's own colour")
          ->check(CLI::IsMember(names(colour_names)));
  app.add_option("--melanin", o.melanin,
                 "EUMELANIN[,PHEOMELANIN], [0, 100]: blond 0.1,0.03, red 0.05,0.8, brown 0.6,0.06, black 8")
      ->delimiter(',')
      ->expected(1, 2)
      ->check(CLI::Range(0.0, 100.0))
      ->excludes(colour);
  o.of_fibres = {
      app.add_option("--eta", look.eta, "index of refraction, [1, 3]")->check(CLI::Range(1.0, 3.0)),
      app.add_option("--beta", o.beta, "ALONG[,ROUND]: roughness, [0.05, 1]; one number for both; marschner takes one")
          ->delimiter(',')
          ->expected(1, 2)
          ->check(CLI::Range(0.05, 1.0))
          ->default_str("0.2,0.3"),
      app.add_option("--tilt", look.tilt, "of the cuticle's scales toward the tip, degrees, [-20, 20]")
          ->check(CLI::Range(-20.0, 20.0))};
  o.of_lobes = {app.add_option("--diffuse", look.diffuse, "kajiya_kay's K_d, on the fibre's colour, [0, 100]")
                    ->check(CLI::Range(0.0, 100.0)),
                app.add_option("--specular", look.specular, "kajiya_kay's K_s, of a white highlight, [0, 100]")
                    ->check(CLI::Range(0.0, 100.0)),
                app.add_option("--exponent", look.exponent, "of kajiya_kay's highlight, [0, 10000]")
                    ->check(CLI::Range(0.0, 10000.0))};
  for (const auto& options : {o.of_fibres, o.of_lobes}) {
    for (CLI::Option* option : options)
      option->capture_default_str();
  }
}

void read_look(const look_options& o, fibre_look& look) {
  look.model = model_names.at(o.model);
  look.passing = attenuation_names.at(o.passing);
  for (const CLI::Option* option : o.of_fibres) {
    const bool is_used = look.passing == attenuation::fresnel && option->get_name() == "--eta";
    if (look.model == bsdf_model::kajiya_kay && option->count() > 0 && !is_used) {
      const std::string or_else = option->get_name() == "--eta" ? " or --attenuation fresnel" : "";
      throw std::invalid_argument(option->get_name() + " needs --bsdf marschner, chiang or dual_scattering" + or_else);
    }
  }
  for (const CLI::Option* option : o.of_lobes) {
    if (look.model != bsdf_model::kajiya_kay && option->count() > 0) {
      throw std::invalid_argument(option->get_name() + " needs --bsdf kajiya_kay");
    }
  }
  if (look.model == bsdf_model::marschner && o.beta.size() > 1) {
    throw std::invalid_argument("--beta: marschner's fibre is smooth round its axis and takes one number");
  }
  if (!o.beta.empty()) {
    look.beta_m = o.beta.front();
    look.beta_n = o.beta.back();
  }
  if (!o.colour.empty()) look.pigment = melanin_of<float>(colour_names.at(o.colour));
  if (!o.melanin.empty()) look.pigment = {o.melanin.front(), o.melanin.size() > 1 ? o.melanin.back() : 0.0F};
}

std::string name_of(bsdf_model model) {
  return name_in(model_names, model);
}

}  // namespace pelage::frame
