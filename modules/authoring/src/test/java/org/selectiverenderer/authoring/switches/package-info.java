/** Tests of the package of that name. */
@NullMarked
package org.selectiverenderer.authoring.switches;

import org.jspecify.annotations.NullMarked;
