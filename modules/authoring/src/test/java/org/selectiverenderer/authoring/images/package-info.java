/** Tests of the package of that name. */
@NullMarked
package org.selectiverenderer.authoring.images;

import org.jspecify.annotations.NullMarked;
