/** Commands in processes of their own. */
@NullMarked
package org.selectiverenderer.app.process;

import org.jspecify.annotations.NullMarked;
