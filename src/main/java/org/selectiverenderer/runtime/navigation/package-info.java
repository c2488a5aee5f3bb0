/**
 * The viewer: where it is, how it walks, what it bumps into, what a ray hits.
 *
 * <p>In: the instance tree, input as intentions (forward, turn), recorded paths. Out: the {@link
 * org.selectiverenderer.runtime.navigation.Viewer}'s pose. No windows, no GL.
 */
@NullMarked
package org.selectiverenderer.runtime.navigation;

import org.jspecify.annotations.NullMarked;
