// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupler/cli/case_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

namespace fissura::coupler {

namespace {

constexpr double plan_extent = 900, margin = 40, legend_width = 260;  // pixels
constexpr double row = 22;
constexpr double arrow_length = 60;
constexpr const char* set_colours[] = {"#0072b2", "#009e73", "#cc79a7", "#56b4e9", "#8c6d31", "#7f3c8d"};
constexpr const char* open_colour = "#d55e00";
constexpr const char* intact_colour = "#999999";
constexpr const char* cleaning_colour = "#e69f00";

std::string escaped(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    if (letter == '&')
      result += "&amp;";
    else if (letter == '<')
      result += "&lt;";
    else if (letter == '>')
      result += "&gt;";
    else
      result += letter;
  }
  return result;
}

/// The greatest of 1, 2 and 5 times a power of ten that is at most `length`.
double round_length(double length) {
  const double power = std::pow(10, std::floor(std::log10(length)));
  for (const double factor : {5.0, 2.0})
    if (factor * power <= length) return factor * power;
  return power;
}

class Picture {
 public:
  explicit Picture(const CaseReading& reading)
      : reading_(reading),
        case_(reading.value),
        scale_(plan_extent / std::max(case_.domain.width, case_.domain.height)),
        width_(scale_ * case_.domain.width),
        height_(std::max(scale_ * case_.domain.height, 560.0)) {}

  std::string draw() {
    const double full_width = width_ + 2 * margin + legend_width, full_height = height_ + 2 * margin;
    text_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 "
        "{0:.0f} {1:.0f}\" "
        "font-family=\"sans-serif\" font-size=\"13\">\n<rect width=\"100%\" height=\"100%\" "
        "fill=\"white\"/>\n",
        full_width, full_height);
    text_ += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"15\">{}</text>\n", margin, margin - 14,
                         escaped(case_.title));
    text_ += fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"#fafafa\" stroke=\"black\"/>\n",
        margin, margin, width_, scale_ * case_.domain.height);
    cleaning_places();
    lines();
    perforations();
    legend();
    return text_ + "</svg>\n";
  }

 private:
  [[nodiscard]] double x(double east) const { return margin + scale_ * (east + case_.domain.width / 2); }
  [[nodiscard]] double y(double north) const { return margin + scale_ * (case_.domain.height / 2 - north); }

  std::string colour_of(const FractureLine& line) {
    if (line.kind == FractureKind::open) return open_colour;
    if (line.kind == FractureKind::intact) return intact_colour;
    const std::string set = line.set.empty() ? "single natural fractures" : "set " + line.set;
    const auto known = std::find(sets_.begin(), sets_.end(), set);
    const auto index = static_cast<std::size_t>(known - sets_.begin());
    if (known == sets_.end()) sets_.push_back(set);
    return set_colours[index % std::size(set_colours)];
  }

  void lines() {
    for (const FractureLine& line : case_.fractures) {
      const std::string colour = colour_of(line);
      ++counts_[line.kind == FractureKind::natural ? colour_name(line) : kind_name(line.kind)];
      text_ += "<polyline fill=\"none\" points=\"";
      for (const Point& point : line.points) text_ += fmt::format("{:.2f},{:.2f} ", x(point[0]), y(point[1]));
      text_ += fmt::format("\" stroke=\"{}\" stroke-width=\"{}\"{}><title>{}</title></polyline>\n", colour,
                           line.kind == FractureKind::open ? 3 : 1.4,
                           line.kind == FractureKind::intact ? " stroke-dasharray=\"6 4\"" : "",
                           escaped(line.name));
    }
  }

  [[nodiscard]] static std::string colour_name(const FractureLine& line) {
    return line.set.empty() ? "single natural fractures" : "set " + line.set;
  }
  [[nodiscard]] static std::string kind_name(FractureKind kind) {
    return kind == FractureKind::open ? "open" : "rock that can break";
  }

  void cleaning_places() {
    for (const CleaningRecord& record : reading_.natural_fractures.cleaning)
      text_ += fmt::format(
          "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{}\" fill=\"{}\" stroke=\"{}\"><title>{} {}: "
          "{}</title></circle>\n",
          x(record.at[0]), y(record.at[1]), record.action == CleaningAction::removed ? 5 : 3.5,
          record.action == CleaningAction::removed ? "none" : cleaning_colour, cleaning_colour,
          escaped(record.trace), name(record.action), escaped(record.cause));
  }

  void perforations() {
    for (const Perforation& perforation : case_.injection.perforations)
      text_ += fmt::format(
          "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"5\" fill=\"white\" stroke=\"black\" "
          "stroke-width=\"2\"/>\n",
          x(perforation.position[0]), y(perforation.position[1]));
  }

  void legend() {
    left_ = margin + width_ + 25;
    down_ = margin + 12;
    for (std::size_t i = 0; i < sets_.size(); ++i) {
      const auto count = counts_.find(sets_[i]);
      line_entry(fmt::format("{} ({})", sets_[i], count == counts_.end() ? 0 : count->second),
                 set_colours[i % std::size(set_colours)], "");
    }
    if (counts_.contains("open")) line_entry("open", open_colour, "");
    if (counts_.contains("rock that can break"))
      line_entry("rock that can break", intact_colour, " stroke-dasharray=\"6 4\"");
    if (!case_.injection.perforations.empty()) circle_entry("perforation", "white", "black");
    if (!reading_.natural_fractures.cleaning.empty()) {
      circle_entry("end or place changed by cleaning", cleaning_colour, cleaning_colour);
      circle_entry("removed by cleaning", "none", cleaning_colour);
    }
    scale_bar();
    north_arrow();
    stresses();
  }

  void say(double at, const std::string& words, const char* anchor = "start") {
    text_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", at, down_ + 4,
                         anchor, escaped(words));
  }

  void line_entry(const std::string& words, const char* colour, const char* style) {
    text_ += fmt::format(
        "<line x1=\"{0:.1f}\" y1=\"{1:.1f}\" x2=\"{2:.1f}\" y2=\"{1:.1f}\" stroke=\"{3}\" "
        "stroke-width=\"2\"{4}/>\n",
        left_, down_, left_ + 26, colour, style);
    say(left_ + 34, words);
    down_ += row;
  }

  void circle_entry(const std::string& words, const char* fill, const char* stroke) {
    text_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"5\" fill=\"{}\" stroke=\"{}\"/>\n",
                         left_ + 13, down_, fill, stroke);
    say(left_ + 34, words);
    down_ += row;
  }

  void scale_bar() {
    down_ += row;
    const double metres = round_length(140 / scale_), pixels = scale_ * metres;
    text_ += fmt::format("<path d=\"M{0:.1f} {1:.1f}v8h{2:.1f}v-8\" fill=\"none\" stroke=\"black\"/>\n",
                         left_, down_ - 6, pixels);
    say(left_ + pixels + 10, fmt::format("{:g} m", metres));
    down_ += row;
  }

  void arrow(double from_x, double from_y, double to_x, double to_y, const char* colour) {
    const double dx = to_x - from_x, dy = to_y - from_y, length = std::hypot(dx, dy);
    const double ux = dx / length, uy = dy / length;
    text_ += fmt::format(
        "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" stroke-width=\"2\"/>\n",
        from_x, from_y, to_x, to_y, colour);
    text_ += fmt::format("<polygon points=\"{:.1f},{:.1f} {:.1f},{:.1f} {:.1f},{:.1f}\" fill=\"{}\"/>\n",
                         to_x + 4 * ux, to_y + 4 * uy, to_x - 8 * ux - 5 * uy, to_y - 8 * uy + 5 * ux,
                         to_x - 8 * ux + 5 * uy, to_y - 8 * uy - 5 * ux, colour);
  }

  void north_arrow() {
    down_ += row;
    arrow(left_ + 13, down_ + 40, left_ + 13, down_, "black");
    say(left_ + 28, "N");
    down_ += 3 * row;
  }

  /// Arrows along a principal stress: towards one another if it is compression.
  void stress_arrows(double centre_x, double centre_y, Point along, double stress, double greatest,
                     const char* colour) {
    const double long_by = std::max(12.0, arrow_length * std::abs(stress) / greatest), gap = 8;
    for (const double side : {1.0, -1.0}) {
      const double near_x = centre_x + side * gap * along[0], near_y = centre_y - side * gap * along[1];
      const double far_x = centre_x + side * (gap + long_by) * along[0],
                   far_y = centre_y - side * (gap + long_by) * along[1];
      if (stress < 0)
        arrow(far_x, far_y, near_x, near_y, colour);
      else
        arrow(near_x, near_y, far_x, far_y, colour);
    }
  }

  void stresses() {
    const auto& [xx, yy, xy, zz] = case_.in_situ.stress;
    const double mean = (xx + yy) / 2, radius = std::hypot((xx - yy) / 2, xy);
    const double angle = std::atan2(2 * xy, xx - yy) / 2;  // of the most tensile principal stress, from x
    const std::array<double, 2> value{mean + radius, mean - radius};
    const double greatest = std::max({std::abs(value[0]), std::abs(value[1]), 1.0});
    say(left_, "effective in-situ stress, compression");
    const double centre_x = left_ + 90, centre_y = down_ + 100;
    stress_arrows(centre_x, centre_y, {std::cos(angle), std::sin(angle)}, value[0], greatest, "#666666");
    stress_arrows(centre_x, centre_y, {-std::sin(angle), std::cos(angle)}, value[1], greatest, "black");
    down_ = centre_y + 95;
    say(left_, fmt::format("greatest {:.4g} MPa (black)", -value[1] / 1e6));
    down_ += row;
    say(left_, fmt::format("least {:.4g} MPa (grey)", -value[0] / 1e6));
  }

  const CaseReading& reading_;
  const Case& case_;
  double scale_, width_, height_;
  double left_ = 0, down_ = 0;  // of the next entry of the legend
  std::vector<std::string> sets_;
  std::map<std::string, int> counts_;
  std::string text_;
};

}  // namespace

std::string case_picture(const CaseReading& reading) {
  return Picture(reading).draw();
}

}  // namespace fissura::coupler
