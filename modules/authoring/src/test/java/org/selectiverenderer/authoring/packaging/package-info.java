/** Tests of the package of that name. */
@NullMarked
package org.selectiverenderer.authoring.packaging;

import org.jspecify.annotations.NullMarked;
