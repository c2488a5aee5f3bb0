/** Tests of what is read back of a study. */
@NullMarked
package org.selectiverenderer.study.dataset;

import org.jspecify.annotations.NullMarked;
