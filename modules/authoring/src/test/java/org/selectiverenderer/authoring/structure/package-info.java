/** Tests of the edits of a scene's structure. */
@NullMarked
package org.selectiverenderer.authoring.structure;

import org.jspecify.annotations.NullMarked;
