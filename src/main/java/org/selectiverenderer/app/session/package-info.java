/**
 * A participant's session with real windows: the steps that {@code experiment.session} knows, each
 * shown by the same code as {@code run} shows a scene.
 *
 * <p>In: a {@link org.selectiverenderer.experiment.session.Session} begun or resumed, and a {@link
 * org.selectiverenderer.app.session.SessionDesk}, where participant and experimenter sit. Out: the
 * session's files, and how it ended.
 *
 * <p>May use {@code app} and {@code experiment}; Swing is behind the desk.
 */
@NullMarked
package org.selectiverenderer.app.session;

import org.jspecify.annotations.NullMarked;
