package org.selectiverenderer.testing;

import java.lang.annotation.ElementType;
import java.lang.annotation.Inherited;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junit.jupiter.api.extension.ExtendWith;

/**
 * A test that shows windows, here or in a process that it starts. It {@linkplain RequiresDisplay
 * requires a display}, and has the screen to itself: tests run in two processes, and a window of
 * the other one would lie over what is to be clicked or looked at, or take the keyboard away.
 */
@Target({ElementType.TYPE, ElementType.METHOD})
@Retention(RetentionPolicy.RUNTIME)
@Inherited
@RequiresDisplay
@ExtendWith(ScreenLockExtension.class)
public @interface ShowsWindows {}
