/**
 * Optional extensions of the standard's Scene Access Interface. A program for any browser tests for
 * these interfaces by {@code instanceof}, and works without them: the embedded browser implements
 * them, Xj3D does not.
 *
 * <p>Interfaces only. Uses {@code org.web3d.x3d.sai}.
 */
@NullMarked
package org.selectiverenderer.sai;

import org.jspecify.annotations.NullMarked;
