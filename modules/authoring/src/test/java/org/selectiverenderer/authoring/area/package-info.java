/** Tests of the package of that name. */
@NullMarked
package org.selectiverenderer.authoring.area;

import org.jspecify.annotations.NullMarked;
