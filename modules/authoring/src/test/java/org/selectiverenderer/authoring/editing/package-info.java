/** Tests of what an author does to a scene's text by hand. */
@NullMarked
package org.selectiverenderer.authoring.editing;

import org.jspecify.annotations.NullMarked;
