@NullMarked
package org.selectiverenderer.app.narration;

import org.jspecify.annotations.NullMarked;
