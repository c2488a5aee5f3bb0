/** Tests of repairs of geometry. */
@NullMarked
package org.selectiverenderer.authoring.geometry;

import org.jspecify.annotations.NullMarked;
