@NullMarked
package org.selectiverenderer.enricher.preview;

import org.jspecify.annotations.NullMarked;
