/**
 * Sources of trackers on the network: opentrack's datagrams, VRPN, and text lines over TCP.
 *
 * <p>In: hosts and ports. Out: {@link org.selectiverenderer.tracker.pipeline.PoseSource}s. Uses
 * {@code tracker}, {@code tracker.pipeline} and {@code tracker.text}; nothing is sent except for
 * the handshake of a protocol.
 */
@NullMarked
package org.selectiverenderer.tracker.net;

import org.jspecify.annotations.NullMarked;
