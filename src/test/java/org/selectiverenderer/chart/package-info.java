/** Tests of charts. */
@org.jspecify.annotations.NullMarked
package org.selectiverenderer.chart;
