/** Tests of trigger signals. */
@NullMarked
package org.selectiverenderer.app.trigger;

import org.jspecify.annotations.NullMarked;
