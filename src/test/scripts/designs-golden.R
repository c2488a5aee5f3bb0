# Makes designs-golden.csv; see README.md beside this file.
suppressMessages(library(afex))
arguments <- commandArgs(trailingOnly = TRUE)
folder <- arguments[1]
lines <- "design,effect,df1,df2,F,ges,p"

trials <- function(design) read.csv(file.path(folder, paste0(design, ".csv")), colClasses = c(participant = "character"))

analyse <- function(label, design, measure, between = NULL, within = NULL, where = function(d) d) {
  d <- where(if (is.data.frame(design)) design else trials(design))
  d$value <- as.numeric(d[[measure]])
  # The mean of a participant's trials at the same levels.
  d <- aggregate(d["value"], d[c("participant", between, within)], mean)
  for (name in c(between, within)) d[[name]] <- factor(d[[name]])
  # Greenhouse and Geisser's correction of p is not applied, as by --sphericity none.
  table <- suppressMessages(suppressWarnings(aov_ez("participant", "value", d, between = between, within = within,
    anova_table = list(correction = "none", es = "ges"), check_contrasts = TRUE)))$anova_table
  for (effect in rownames(table))
    lines <<- c(lines, sprintf("%s,%s,%.15g,%.15g,%.15g,%.15g,%.15g", label, effect, table[effect, "num Df"],
      table[effect, "den Df"], table[effect, "F"], table[effect, "ges"], table[effect, "Pr(>F)"]))
}

right <- function(d) d[d$correct == "yes", ]
scored <- function(d) { d$correct <- as.numeric(d$correct == "yes"); d }
analyse("between", "rooms-between", "there.there", between = "quality")
analyse("mixed", "rooms-between", "there.there", between = "quality", within = "area")
analyse("time", "quality-and-light", "ms", within = c("quality", "light"), where = right)
analyse("share", "quality-and-light", "correct", within = c("quality", "light"), where = scored)
analyse("change", "change-blindness", "ms", within = "change", where = right)
analyse("staircase", "levels-of-detail", "corners", within = "side")

# d' of each participant at the same levels, with the log-linear correction (Hautus 1995).
sensitivity <- function(d, by) {
  d <- d[d$response != "", ]
  do.call(rbind, lapply(split(d, d[c("participant", by)], drop = TRUE), function(x) {
    present <- x$answer == "f"
    yes <- x$response == "f"
    rate <- function(which) (sum(yes[which]) + 0.5) / (sum(which) + 1)
    cbind(x[1, c("participant", by)], dprime = qnorm(rate(present)) - qnorm(rate(!present)))
  }))
}
analyse("sensitivity", sensitivity(trials("quality-and-light"), c("quality", "light")), "dprime",
  within = c("quality", "light"))

# The staircases of levels-of-detail again: two down, one up; the last six of eight reversals count.
threshold <- function(x, names = c(4, 6, 8, 12, 16, 24)) {
  level <- 1; row <- 0; before <- 0; turns <- c()
  go <- function(towards) {
    if (before == -towards) turns <<- c(turns, level)
    before <<- towards
    level <<- min(length(names), max(1, level + towards))
  }
  for (i in seq_len(nrow(x))) {
    stopifnot(names[level] == x$corners[i])
    if (x$correct[i] != "yes") { row <- 0; go(-1) }
    else { row <- row + 1; if (row == 2) { row <- 0; go(1) } }
  }
  stopifnot(length(turns) == 8)
  mean(names[turns[3:8]])
}
stairs <- trials("levels-of-detail")
analyse("threshold", do.call(rbind, lapply(split(stairs, stairs[c("participant", "side")]), function(x)
  cbind(x[1, c("participant", "side")], corners = threshold(x)))), "corners", within = "side")
writeLines(lines, arguments[2])
