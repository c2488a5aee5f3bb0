/** Tests of making meshes ready. */
@NullMarked
package org.selectiverenderer.runtime.render.mesh;

import org.jspecify.annotations.NullMarked;
