/** Tests of the package. */
@org.jspecify.annotations.NullMarked
package org.selectiverenderer.statistics.simulation;
