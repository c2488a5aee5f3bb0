/** The audio of instructions and questionnaires. */
@NullMarked
package org.selectiverenderer.app.narration;

import org.jspecify.annotations.NullMarked;
