/** The windows of a session, driven by mouse and keys on a real screen. */
@NullMarked
package org.selectiverenderer.app.window;

import org.jspecify.annotations.NullMarked;
