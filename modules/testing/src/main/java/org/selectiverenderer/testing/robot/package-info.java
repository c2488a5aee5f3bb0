/** A robot that clicks and types in windows as a person does, and finds controls by their names. */
@NullMarked
package org.selectiverenderer.testing.robot;

import org.jspecify.annotations.NullMarked;
