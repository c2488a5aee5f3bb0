/** Tests of the package of that name. */
@NullMarked
package org.selectiverenderer.authoring.routes;

import org.jspecify.annotations.NullMarked;
