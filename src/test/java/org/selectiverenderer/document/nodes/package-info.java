/** Tests of the package of that name. */
@NullMarked
package org.selectiverenderer.document.nodes;

import org.jspecify.annotations.NullMarked;
