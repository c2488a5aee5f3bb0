/** Tests of scenes as the light sees them. */
@NullMarked
package org.selectiverenderer.radiosity.scene;

import org.jspecify.annotations.NullMarked;
