/**
 * Trackers on the network: opentrack's datagrams, a VRPN client, lines over TCP.
 *
 * <p>In: hosts and ports. Out: {@link org.selectiverenderer.tracker.live.PoseSource}s. Uses {@code
 * tracker}, {@code tracker.live} and {@code tracker.text}; nothing is sent but what a protocol's
 * hand-shake asks for.
 */
@NullMarked
package org.selectiverenderer.tracker.net;

import org.jspecify.annotations.NullMarked;
