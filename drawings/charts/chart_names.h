// What stands beside the curves of a chart, or in its legend.
#pragma once

#include <optional>
#include <vector>

#include "drawings/charts/chart.h"
#include "drawings/charts/chart_curves.h"

namespace epure::drawings {

// The name of each curve where it stands freely beside the curve inside the frame, nearer to it than to any other;
// nothing when there is a curve without such a place. Fixed, as label placement does not know which curve is meant.
// `figure` holds the chart's marks and nothing else. `others`: the labels of its special points, which have less
// choice and come first.
std::optional<std::vector<Writing>> direct_names(const Chart& chart, const ChartMap& map, const Figure& figure,
                                                 const std::vector<Label>& others, Box box);

// The labels of special points and reference lines.
std::vector<Label> marker_labels(const Chart& chart, const ChartMap& map);

// The rows of a legend `width` mm wide: which curves stand in which row.
std::vector<std::vector<std::size_t>> legend_rows(const Chart& chart, double width);
double legend_width(const Chart& chart, const std::vector<std::size_t>& row);
// `top_right`: where the upper edge of the first row ends.
void draw_legend(const Chart& chart, const std::vector<Look>& looks,
                 const std::vector<std::vector<std::size_t>>& rows, Point top_right, Figure& figure);

inline constexpr double legend_row_height = 5;  // mm
inline constexpr double curve_label_size = 3.5, marker_label_size = 3;

}  // namespace epure::drawings
