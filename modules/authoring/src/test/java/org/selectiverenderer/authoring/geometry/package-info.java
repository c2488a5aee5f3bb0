/** Tests of repairs of geometry. */
@org.jspecify.annotations.NullMarked
package org.selectiverenderer.authoring.geometry;
