/** Tests of lamps. */
@NullMarked
package org.selectiverenderer.radiosity.light;

import org.jspecify.annotations.NullMarked;
