/** Tests of the package of that name. */
@NullMarked
package org.selectiverenderer.authoring.importing;

import org.jspecify.annotations.NullMarked;
