/** Tests of the meshes that carry light. */
@NullMarked
package org.selectiverenderer.radiosity.mesh;

import org.jspecify.annotations.NullMarked;
