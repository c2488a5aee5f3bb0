/**
 * The pages for people, held to what is there: their links, the commands of the stories, the
 * navigation of the site, and the tables that are written from schemas.
 */
@NullMarked
package org.selectiverenderer.pages;

import org.jspecify.annotations.NullMarked;
