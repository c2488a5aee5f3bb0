/** Tests of the package of that name. */
@NullMarked
package org.selectiverenderer.document.area;

import org.jspecify.annotations.NullMarked;
