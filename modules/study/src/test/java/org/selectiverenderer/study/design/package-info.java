@NullMarked
package org.selectiverenderer.study.design;

import org.jspecify.annotations.NullMarked;
