@NullMarked
package org.selectiverenderer.study.definition;

import org.jspecify.annotations.NullMarked;
