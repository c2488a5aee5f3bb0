@NullMarked
package org.selectiverenderer.study.headlog;

import org.jspecify.annotations.NullMarked;
