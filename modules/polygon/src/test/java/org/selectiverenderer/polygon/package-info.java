/** Tests of the polygon statistics, the thesis's own figures among them. */
@org.jspecify.annotations.NullMarked
package org.selectiverenderer.polygon;
