/**
 * Asks the user about what a study or a settings file wants beyond its own folder, for all commands
 * in one way: the list is shown once, on the terminal or by a window of the caller's; the answer is
 * remembered in the user's settings folder; {@code --trust} agrees without a question; where nobody
 * can be asked, the command ends with the line to type.
 *
 * <p>In: {@link org.selectiverenderer.base.trust.PermissionRequests}. Uses {@code command.output}
 * and {@code base.trust}; no window, which callers bring as a {@link
 * org.selectiverenderer.command.trust.TrustPrompt}.
 */
@NullMarked
package org.selectiverenderer.command.trust;

import org.jspecify.annotations.NullMarked;
