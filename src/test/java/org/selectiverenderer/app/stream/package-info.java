/** Tests of what is sent to the Lab Streaming Layer and recorded from it. */
@NullMarked
package org.selectiverenderer.app.stream;

import org.jspecify.annotations.NullMarked;
