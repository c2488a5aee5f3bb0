@NullMarked
package org.selectiverenderer.study.session;

import org.jspecify.annotations.NullMarked;
