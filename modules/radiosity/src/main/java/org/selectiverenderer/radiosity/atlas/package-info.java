/**
 * The lightmap atlas: every triangle of a scene gets a part of a lightmap page of its own.
 *
 * <p>In: the bodies of a {@link org.selectiverenderer.radiosity.scene.RadiosityScene}, the file
 * that each is written to, texels per metre and a budget of bytes. Surfaces are cut into charts
 * that are flattened with little stretch, charts are packed into the pages of their file, and each
 * texel of a chart knows the surface point that it shows. Out: {@link
 * org.selectiverenderer.radiosity.atlas.Atlas}, or the one sentence why the budget cannot be kept.
 * Uses {@code radiosity.scene}, {@code radiosity.trace}, {@code geometry} and {@code
 * geometry.mesh}.
 *
 * <pre>
 * body -> TriangleAdjacency: neighbours -> ChartGrower, ChartMerger: charts -> Overlaps: cut where they
 *   lie on themselves -> UvCharts: flat, in the smallest box
 * Density -> ChartRectangles: whole texels -> AtlasPacker, Skyline: pages -> Rasterizer: AtlasPage
 * </pre>
 *
 * <p>Between charts lie gutters of two texels, and of one around each page: bilinear filtering
 * meets texels of its own chart and of the gutter beside it only, also where a page repeats. The
 * first smaller level of a mipmap is safe; further levels mix charts.
 */
@NullMarked
package org.selectiverenderer.radiosity.atlas;

import org.jspecify.annotations.NullMarked;
