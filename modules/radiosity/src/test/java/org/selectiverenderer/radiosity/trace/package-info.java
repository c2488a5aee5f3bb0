/** Tests of rays against triangles. */
@NullMarked
package org.selectiverenderer.radiosity.trace;

import org.jspecify.annotations.NullMarked;
