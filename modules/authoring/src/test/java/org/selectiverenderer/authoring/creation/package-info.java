/** Tests of the package of that name. */
@NullMarked
package org.selectiverenderer.authoring.creation;

import org.jspecify.annotations.NullMarked;
