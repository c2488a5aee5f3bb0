/** Tests of JSON that people write and that programs write. */
@NullMarked
package org.selectiverenderer.validation.settings;

import org.jspecify.annotations.NullMarked;
