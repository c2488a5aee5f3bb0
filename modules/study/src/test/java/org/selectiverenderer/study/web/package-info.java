/** Tests of the import of sessions that ran in browsers. */
@NullMarked
package org.selectiverenderer.study.web;

import org.jspecify.annotations.NullMarked;
