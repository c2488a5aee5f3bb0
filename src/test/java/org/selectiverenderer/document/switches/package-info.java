/** Tests of the package of that name. */
@NullMarked
package org.selectiverenderer.document.switches;

import org.jspecify.annotations.NullMarked;
