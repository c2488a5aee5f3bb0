/** Tests of what is, and what must not be, in an anonymised package. */
@NullMarked
package org.selectiverenderer.study.archive;

import org.jspecify.annotations.NullMarked;
