/**
 * What a file that somebody sends asks for beyond its own folder, and what the user has answered.
 *
 * <p>A study, or a settings file beside a scene, can name folders, hosts, trackers and streams. It
 * gets none of them before the user has seen the list. In: requests. Out: whether the user has
 * agreed to the same requests of the same folder before ({@link
 * org.selectiverenderer.base.trust.TrustStore}). Commands and windows ask. Uses {@code base.files}.
 */
@NullMarked
package org.selectiverenderer.base.trust;

import org.jspecify.annotations.NullMarked;
