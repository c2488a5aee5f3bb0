/**
 * Tests of charts; and the plots of docs/performance.md, which the program itself never draws: bars
 * in groups or in parts, and curves over logarithmic axes, as SVG.
 */
@org.jspecify.annotations.NullMarked
package org.selectiverenderer.chart;
