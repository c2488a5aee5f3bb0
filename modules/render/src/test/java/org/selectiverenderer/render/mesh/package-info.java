/** Tests of making meshes ready. */
@NullMarked
package org.selectiverenderer.render.mesh;

import org.jspecify.annotations.NullMarked;
