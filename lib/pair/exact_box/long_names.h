/* long_names.h: names of what pair/exact_box shares between its files, where it is compiled for
 * long numbers (wide.h). */
#ifndef FMB_PAIR_LONG_NAMES_H
#define FMB_PAIR_LONG_NAMES_H

#ifdef FMB_WIDE_LONG
#define fmb_exact_box_are_apart     fmb_long_box_are_apart
#define fmb_exact_box_is_farthest   fmb_long_box_is_farthest
#define fmb_exact_box_find_prices   fmb_long_box_find_prices
#define fmb_exact_box_find_loss     fmb_long_box_find_loss
#define fmb_exact_box_load_q        fmb_long_box_load_q
#define fmb_exact_box_load          fmb_long_box_load
#define fmb_exact_box_list_costs    fmb_long_box_list_costs
#define fmb_exact_box_value         fmb_long_box_value
#define fmb_exact_box_value_roughly fmb_long_box_value_roughly
#define fmb_exact_box_value_outward fmb_long_box_value_outward
#define fmb_exact_box_walk_exactly  fmb_long_box_walk_exactly
#define fmb_exact_box_round_outward fmb_long_box_round_outward
#define fmb_exact_box_state         fmb_long_box_state
#define fmb_exact_box_is_off_end    fmb_long_box_is_off_end
#define fmb_exact_box_near_values   fmb_long_box_near_values
#define fmb_exact_box_take_basis    fmb_long_box_take_basis
#define fmb_exact_box_bound_way     fmb_long_box_bound_way
#define fmb_exact_box_need_whole    fmb_long_box_need_whole
#define fmb_exact_box_need_low      fmb_long_box_need_low
#define fmb_exact_box_find_low      fmb_long_box_find_low
#define fmb_exact_box_remainder     fmb_long_box_remainder
#define fmb_exact_box_list_column   fmb_long_box_list_column
#define fmb_exact_box_walk_start    fmb_long_box_walk_start
#define fmb_exact_box_walk_to       fmb_long_box_walk_to
#define fmb_wide_dot                fmb_long_number_dot
#define fmb_wide_divide_exactly     fmb_long_number_divide_exactly
#define fmb_wide_to_doubles         fmb_long_number_to_doubles
#endif

#endif
