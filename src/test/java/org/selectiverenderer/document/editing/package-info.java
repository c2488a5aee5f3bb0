/** Tests of what an author does to a scene's text by hand. */
@NullMarked
package org.selectiverenderer.document.editing;

import org.jspecify.annotations.NullMarked;
