/** Tests of the package of that name. */
@NullMarked
package org.selectiverenderer.authoring.nodes;

import org.jspecify.annotations.NullMarked;
