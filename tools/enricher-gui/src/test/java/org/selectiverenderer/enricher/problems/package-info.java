@NullMarked
package org.selectiverenderer.enricher.problems;

import org.jspecify.annotations.NullMarked;
