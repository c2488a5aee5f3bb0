/**
 * The completion popup below the caret of a text: Down and Up select, Enter or Tab accepts, Escape
 * closes. The caller computes the proposals and inserts the accepted one. For the event dispatch
 * thread.
 */
@NullMarked
package org.selectiverenderer.enricher.completion;

import org.jspecify.annotations.NullMarked;
