/**
 * What a browser may show beyond the standard's Scene Access Interface. A program that is made for
 * any browser asks for these interfaces by {@code instanceof}, and does without where they are
 * missing: the embedded browser implements them, Xj3D does not.
 *
 * <p>Interfaces only. Uses {@code org.web3d.x3d.sai}.
 */
@NullMarked
package org.selectiverenderer.sai;

import org.jspecify.annotations.NullMarked;
